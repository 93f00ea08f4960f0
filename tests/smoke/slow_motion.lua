-- Time runs at a quarter and the camera's way with it, and both come back; speeds are those of the game's own time.
level("showroom") room(16)
throw{tick=10, x=-0.087, y=0.085}
run(60)
expect_power_ups("slowmotion", 1)
expect_speed{v=3, within=0.001}
expect_position{z=3, within=0.001}
use("slowmotion")
restore_at(150)
run(540)
expect_speed{v=3, within=0.001}
-- 480 ticks slow, of which 32 on the way down: 19.625 and 112 of the game's ticks, 1/20 m each.
expect_position{z=3 + (19.625 + 112) / 20, within=0.01}
run(600)
-- 40 less for down and up, then it is as ever: 152 of the game's ticks in 512, and 28 more.
expect_position{z=3 + (152 + 28) / 20, within=0.01}
expect_power_ups("slowmotion", 0)
expect_problems(0)
