-- A door with a button above it: a hit on the button opens it. Nothing of it breaks.
level("showroom") room(11)
throw{tick=60, x=0, y=0.19}
run(70)
expect_cleared(0)
run(120)
expect_cleared(1)
run(420)
expect_crashes(0)
expect_broken(0)
expect_problems(0)
