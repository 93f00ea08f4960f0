-- A block stands on the floor until it is hit.
level("showroom") room(7)
run(60)
expect_broken(0)
throw{tick=60, x=0, y=-0.2}
run(140)
expect_broken(1, 3)
expect_cleared(1)
run(420)
expect_crashes(0)
expect_problems(0)
