-- A hole in the first window is a way through: one throw at its middle, and no crash.
level("first")
seed(1)
throw{tick=200, x=0, y=0}
run(260)
expect_broken(1, 3)
expect_balls(24)
run(420)
expect_crashes(0)
expect_speed{v=5.5, within=0.01}
expect_problems(0)
expect_finite()
