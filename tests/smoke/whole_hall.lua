-- The whole first room as a good player plays it, saved and restored in the thick of it, and on through the door.
level("first")
seed(1)
throw{tick=10, x=-0.176, y=-0.103}
throw{tick=54, x=0.177, y=-0.103}
throw{tick=141, x=0.287, y=-0.112}
throw{tick=185, x=0.000, y=-0.010}
throw{tick=283, x=-0.298, y=-0.134}
throw{tick=316, x=0.299, y=-0.069}
throw{tick=349, x=-0.300, y=-0.003}
throw{tick=480, x=-0.240, y=0.035}
throw{tick=489, x=0.318, y=-0.142}
throw{tick=518, x=0.020, y=-0.021}
throw{tick=536, x=0.000, y=-0.015}
throw{tick=556, x=0.244, y=0.036}
throw{tick=654, x=0.000, y=-0.010}
throw{tick=687, x=0.000, y=-0.203}
throw{tick=720, x=0.000, y=-0.011}
throw{tick=861, x=-0.066, y=-0.043}
throw{tick=870, x=0.073, y=-0.052}
throw{tick=905, x=0.000, y=-0.104}
throw{tick=1003, x=0.000, y=-0.010}
throw{tick=1047, x=0.000, y=-0.011}
throw{tick=1082, x=0, y=0.02}
throw{tick=1110, x=0.0, y=0.06}
throw{tick=1118, x=0, y=0.04}
throw{tick=1178, x=-0.333, y=-0.201}
throw{tick=1221, x=0.331, y=-0.199}
throw{tick=1363, x=-0.265, y=0.014}
throw{tick=1372, x=0.000, y=-0.016}
throw{tick=1381, x=0.000, y=-0.022}
throw{tick=1390, x=0.365, y=0.004}
throw{tick=1412, x=-0.176, y=0.013}
throw{tick=1421, x=0.000, y=-0.016}
throw{tick=1430, x=0.216, y=0.006}
throw{tick=1468, x=-0.050, y=0.200}   -- the pane that swings back
throw{tick=1500, x=0.000, y=-0.012}
throw{tick=1530, x=0.000, y=-0.012}
run(1000)
expect_crashes(0)
expect_streak(1, 9)
restore_at(1450)
run(1900)
expect_crashes(0)
expect_broken(30, 70)
expect_room(0)
run(1960)
expect_room(1)
expect_crashes(0)
expect_problems(0)
expect_finite()
