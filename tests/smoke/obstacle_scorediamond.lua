-- A diamond hovers at 0.65 over its place and turns: one throw, five balls, and nothing of it hangs in the air.
level("showroom") room(1)
throw{tick=20, x=0, y=-0.037}
run(90)
expect_broken(1)
expect_crystals(1)
expect_balls(25 - 1 + 5)
run(420)
expect_crashes(0)
expect_problems(0)
