-- Water, with things above it that fall in: panes on ropes, and cubes of wood that float.

function init()
	mgMusic("hall")
	mgFogColor(0.18, 0.30, 0.36, 0.72, 0.86, 0.90)
	mgReverb(0.35, 0.7, 0.3)
	local z = 0
	for i = 1, 5 do
		z = z + mgSegment("showroom/pool", -z)
	end
	mgLength(z)
	mgObstacle("suspendwindow", 0, 1, -11, "width=2.4", "height=1.8")
	mgObstacle("suspendcube", 0, 1.2, -25, "width=2.4")
	mgObstacle("suspendwindow", -1, 1, -40, "width=2", "height=1.8")
	mgObstacle("suspendwindow", 1.2, 1, -43, "width=2", "height=1.8")
end
