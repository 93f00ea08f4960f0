-- Depth of field is only seen: the room plays as any other.
level("showroom") room(15)
throw{tick=90, x=0, y=0}
run(200)
restore_at(210)
run(260)
expect_broken(1, 4)
expect_problems(0)
