-- A fan of four arms turns by two radians a second; shot through the hub it falls.
level("showroom") room(9)
run(100)
expect_broken(0)
throw{tick=100, x=0, y=0}
run(180)
expect_broken(1, 4)
restore_at(190)
run(330)
expect_crashes(0)
expect_problems(0)
