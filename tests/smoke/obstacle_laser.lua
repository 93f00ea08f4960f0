-- Lasers: the emitter at the left wall is broken, its beams end, and the way is free.
level("showroom") room(12)
throw{tick=40, x=-0.436, y=0.0}
run(110)
expect_broken(1, 2)
expect_cleared(1)
restore_at(120)
run(330)
expect_crashes(0)
expect_problems(0)
