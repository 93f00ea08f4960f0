-- What is far away is out of focus: it comes into it as one flies on.

function init()
	mgMusic("hall")
	mgFogColor(0.20, 0.24, 0.30, 0.80, 0.84, 0.90)
	mgDepthOfField(5, 9, 1)
	local z = 0
	for i = 1, 5 do
		z = z + mgSegment("showroom/hall", -z)
	end
	mgLength(z)
	mgObstacle("scoretop", -0.8, -1, -7)
	mgObstacle("box", 0.9, -0.6, -9, "sizeX=0.3", "sizeY=0.4", "sizeZ=0.3")
	mgObstacle("suspendwindow", 0, 1, -13, "width=2.4", "height=2")
	mgObstacle("stone", -2.2, 0, -18, "sizeX=0.5", "sizeY=1", "sizeZ=0.5", "color=0.9 0.5 0.2")
	mgObstacle("stone", 2.2, 0, -22, "sizeX=0.5", "sizeY=1", "sizeZ=0.5", "color=0.2 0.5 0.9")
	mgObstacle("suspendwindow", 0, 1, -28, "width=2.4", "height=2")
end
