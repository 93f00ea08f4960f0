-- In zen nothing is counted: no crash in front of the closed glass, no ball spent.
level("first")
mode("zen")
throw{tick=10, x=0, y=0}
run(420)
expect_crashes(0)
expect_balls(25)
expect_position{z=38.5, within=0.001}
expect_finite()
