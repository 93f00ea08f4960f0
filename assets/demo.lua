-- The demonstration: eighteen seconds of the first level. tools/play records and renders it where there is no display.
level("first")
seed(1)
throw{tick=66, x=-0.33, y=-0.17}    -- a crystal on the left
throw{tick=100, x=0.27, y=-0.13}    -- and on the right
throw{tick=185, x=0, y=0}           -- the window
throw{tick=300, x=-0.36, y=-0.15}   -- crystals behind it
throw{tick=315, x=-0.17, y=0.0}
throw{tick=350, x=0.3, y=-0.14}
throw{tick=385, x=0.33, y=-0.1}
throw{tick=470, x=-0.13, y=0.07}    -- panes on ropes
throw{tick=500, x=0.03, y=0.03}
throw{tick=540, x=0.0, y=0.05}
throw{tick=575, x=0.17, y=0.0}
throw{tick=640, x=0.0, y=0.04}      -- bars
throw{tick=680, x=0.0, y=0.0}
throw{tick=715, x=0.0, y=0.05}
throw{tick=740, x=0.0, y=-0.02}
throw{tick=800, x=0.0, y=0.0}       -- a wall of blocks
throw{tick=830, x=0.0, y=0.05}
throw{tick=850, x=-0.12, y=0.0}
throw{tick=870, x=0.1, y=0.0}
throw{tick=900, x=0, y=0.1}
throw{tick=930, x=0, y=0.05}        -- windows one behind the other
throw{tick=990, x=0, y=0.0}
throw{tick=1050, x=0, y=0.0}
run(1080)
expect_broken(8, 60)
expect_finite()
