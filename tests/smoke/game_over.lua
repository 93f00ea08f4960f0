-- Every ball thrown away: the game is over two seconds after the last, and the camera stands still.
level("first")
seed(1)
for i = 0, 24 do
	throw{tick=i, x=0.5, y=0.5}
end
run(30)
expect_balls(0)
expect_speed{v=5.5, within=0.01}
run(240)
expect_speed{v=0, within=0}
expect_finite()
