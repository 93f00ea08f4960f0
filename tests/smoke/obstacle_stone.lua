-- A stone is seen and stops nothing: neither the ball nor the camera.
level("showroom") room(6)
throw{tick=60, x=0, y=0}
run(420)
expect_broken(0)
expect_crashes(0)
expect_problems(0)
