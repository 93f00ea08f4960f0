-- A pyramid: one throw, three balls.
level("showroom") room(0)
throw{tick=20, x=0, y=-0.19}
run(90)
expect_broken(1)
expect_crystals(1)
expect_cleared(1)
expect_balls(25 - 1 + 3)
run(420)
expect_crashes(0)
expect_problems(0)
