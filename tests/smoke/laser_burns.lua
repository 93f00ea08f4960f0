-- Lasers that nobody breaks burn the camera.
level("showroom") room(12)
run(330)
expect_crashes(1, 3)
expect_problems(0)
