-- Each power-up is collected by a ball, held, used, and does what it says.
level("showroom") room(16)
throw{tick=2, x=-0.257, y=0.085}
throw{tick=10, x=-0.087, y=0.085}
throw{tick=18, x=0.09, y=0.085}
throw{tick=26, x=0.29, y=0.095}
run(60)
expect_power_ups("ballfrenzy", 1)
expect_power_ups("slowmotion", 1)
expect_power_ups("nitroballs", 1)
expect_power_ups("barrel", 1)
expect_balls(25 - 4)
expect_explosions(0)

-- Free throws: four in its time cost nothing. They are aimed at the floor and leave the panes to the barrel.
use("ballfrenzy")
for i = 1, 4 do
	throw{tick=60 + 10 * i, x=-0.3 + 0.1 * i, y=-0.3}
end
run(120)
expect_balls(25 - 4)
expect_power_ups("ballfrenzy", 0)

-- A barrel goes with one throw and takes every pane in reach with it.
use("barrel")
throw{tick=122, x=0, y=0}
restore_at(130)
run(200)
expect_explosions(1)
expect_broken(8, 40)

-- Nitro balls explode one by one, in slow motion.
use("nitroballs")
use("slowmotion")
run(240)
throw{tick=240, x=0, y=0}
throw{tick=250, x=0.05, y=0}
restore_at(300)
run(520)
expect_explosions(3)
expect_crashes(0)
expect_finite()
expect_problems(0)
