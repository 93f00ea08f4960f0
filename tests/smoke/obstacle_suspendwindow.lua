-- A pane on four ropes hangs still; a throw breaks it, what is left hangs on or falls.
level("showroom") room(5)
run(60)
expect_broken(0)
throw{tick=60, x=0, y=0}
run(140)
expect_broken(1, 3)
restore_at(150)
run(330)
expect_cleared(1)
expect_crashes(0)
expect_problems(0)
