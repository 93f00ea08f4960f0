-- Three crystals in a row: each wins three balls for the one it cost, and the streak counts them.
level("first")
seed(1)
throw{tick=10, x=-0.176, y=-0.103}
throw{tick=54, x=0.177, y=-0.103}
throw{tick=141, x=0.287, y=-0.112}
run(60)
expect_broken(1)
expect_balls(24 + 3 - 1)
run(170)
expect_streak(3)
expect_balls(25 + 3 * 2)
expect_finite()
