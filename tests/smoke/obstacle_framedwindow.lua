-- A pane in a frame of steel: a hole in it is a way through.
level("showroom") room(4)
throw{tick=60, x=0, y=0}
run(140)
expect_broken(1, 3)
run(330)
expect_cleared(1)
expect_crashes(0)
expect_problems(0)
