-- A beam from wall to wall: broken in the middle there is a way; the rest stays at the walls. Unbroken it is a crash.
level("showroom") room(3)
throw{tick=60, x=0, y=0}
run(140)
expect_broken(1, 2)
run(330)
expect_cleared(1)
expect_crashes(0)
expect_problems(0)
