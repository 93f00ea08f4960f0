-- The second room alone, with a save and a restore on the way. It has 192 m: 6 m/s.
level("first")
seed(3)
room(1)
for i = 0, 12 do
	throw{tick=40 + 70 * i, x=0, y=0}
end
run(120)
expect_position{z=12, within=0.001}
expect_speed{v=6, within=0.001}
restore_at(400)
run(900)
expect_broken(2, 40)
expect_problems(0)
expect_finite()
