-- Water: a ball thrown into it splashes, what breaks above it falls in, and nothing that it does is lost by a restore.
level("showroom") room(14)
throw{tick=30, x=0, y=-0.3}
throw{tick=60, x=0, y=0.05}
run(59)
expect_events("splash", 1)
run(100)
expect_broken(1, 4)
restore_at(140)
run(200)
expect_events("splash", 3)
expect_problems(0)
expect_finite()
