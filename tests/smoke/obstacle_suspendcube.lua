-- A block on four ropes hangs still until it is hit; what is left of it is pushed aside or falls.
level("showroom") room(8)
run(60)
expect_broken(0)
throw{tick=60, x=-0.03, y=0}
throw{tick=100, x=0.03, y=0}
run(140)
expect_broken(1, 4)
restore_at(150)
run(330)
expect_crashes(0, 1)
expect_problems(0)
expect_finite()
