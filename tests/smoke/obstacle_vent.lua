-- A pipe that smokes: nothing to break, nothing in the way.
level("showroom") room(13)
run(120)
expect_events("smoke", 30, 45)
run(300)
expect_crashes(0)
expect_problems(0)
