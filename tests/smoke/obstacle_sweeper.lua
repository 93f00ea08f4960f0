-- A pane slides from side to side; hit in the middle of its swing it leaves a way.
level("showroom") room(10)
throw{tick=170, x=0, y=0}
run(330)
expect_broken(1, 4)
expect_crashes(0)
expect_problems(0)
