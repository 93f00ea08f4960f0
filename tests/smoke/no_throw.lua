-- Nobody throws: the first window is a crash that costs ten balls, and the camera goes on.
level("first")
seed(1)
run(420)
expect_crashes(1)
expect_balls(15)
expect_broken(1, 3)
expect_position{z=38.5, within=0.01}
expect_finite()
