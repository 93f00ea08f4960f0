-- One obstacle in an empty hall, as the level file names it: obstacle, y, z and the parameters p1 to p4 are attributes of the room.

function init()
	mgMusic("hall")
	mgFogColor(0.20, 0.24, 0.30, 0.80, 0.84, 0.90)
	local z = 0
	for i = 1, 4 do
		z = z + mgSegment("showroom/hall", -z)
	end
	mgLength(z)
	mgObstacle(mgGetString("obstacle", "box"), mgGetFloat("x", 0), mgGetFloat("y", 1), mgGetFloat("z", -10), mgGetString("p1", ""),
		mgGetString("p2", ""), mgGetString("p3", ""), mgGetString("p4", ""))
end
