-- The demonstration: twenty seconds of the first level. tools/play records and renders it where there is no display.
level("first")
seed(1)
throw{tick=10, x=-0.176, y=-0.103}    -- a crystal
throw{tick=54, x=0.177, y=-0.103}     -- a crystal
throw{tick=141, x=0.287, y=-0.112}    -- a crystal
throw{tick=185, x=0.000, y=-0.010}    -- a window
throw{tick=283, x=-0.298, y=-0.134}   -- a crystal
throw{tick=316, x=0.299, y=-0.069}    -- a crystal
throw{tick=349, x=-0.300, y=-0.003}   -- a crystal
throw{tick=480, x=-0.244, y=0.035}    -- a pane on ropes
throw{tick=489, x=0.318, y=-0.142}    -- a crystal
throw{tick=518, x=0.030, y=-0.021}    -- a pane on ropes
throw{tick=556, x=0.244, y=0.036}     -- a pane on ropes
throw{tick=654, x=0.000, y=-0.010}    -- the bars
throw{tick=687, x=0.000, y=-0.203}    -- a crystal
throw{tick=720, x=0.000, y=-0.011}    -- the bars
throw{tick=861, x=-0.066, y=-0.043}   -- a wall of blocks
throw{tick=870, x=0.073, y=-0.052}    -- a wall of blocks
throw{tick=905, x=0.000, y=-0.104}    -- a crystal
throw{tick=1003, x=0.000, y=-0.010}   -- a window
throw{tick=1047, x=0.000, y=0.048}    -- what is left of the second
throw{tick=1082, x=0.020, y=0.050}    -- and its rim
throw{tick=1178, x=-0.333, y=-0.201}  -- a crystal
run(1200)
expect_broken(15, 60)
expect_crashes(0)
expect_finite()
