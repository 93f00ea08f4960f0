-- A star hovers at 0.7 over its place and tumbles: one throw, ten balls.
level("showroom") room(2)
throw{tick=20, x=0, y=0}
run(90)
expect_broken(1, 3)
expect_crystals(1)
expect_balls(25 - 1 + 10)
run(420)
expect_crashes(0)
expect_problems(0)
