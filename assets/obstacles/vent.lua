-- A pipe in the ground that lets out smoke.
-- height: of the pipe; rate: puffs a second; speed: of the smoke [m/s]; lean: how far it is blown aside [m/s].

function init()
	height = mgGetFloat("height", 0.5)
	rate = math.max(0.5, math.min(30, mgGetFloat("rate", 20)))
	speed = mgGetFloat("speed", 1.5)
	lean = mgGetFloat("lean", 0.3)
	due = 0
	mgMaterial("steel")
	mgStatic(1)
	mgColor(mgGetColor("color", 0.36, 0.38, 0.42))
	local pipe = mgCreateBody(0, height / 2, 0)
	mgCreateCylinder(pipe, 0.13, height / 2)
	mgColor(0.2, 0.21, 0.24)
	mgCreateCylinder(pipe, 0.17, 0.04, 0, height / 2, 0)
end

function tick()
	due = due + rate / 60
	if due < 1 then
		return
	end
	due = due - 1
	local sway = math.sin(mgObstacleTime() * 1.3) * 0.25
	mgSmoke(0, height + 0.06, 0, lean + sway, speed, 0)
end
