-- Beams from wall to wall, one above the other. They burn whoever flies through them, and end when their emitter is broken.
-- dir: right or left, which way they go; beams: how many; move: how far they go up and down, with speed (radians a second) and offset
-- (default: anywhere); raycast: the emitter stands at the wall it finds on its side, not at its place; strength: force limit.

function init()
	side = mgGetString("dir", "right") == "left" and -1 or 1
	beams = math.max(1, math.min(12, mgGetInt("beams", 5)))
	move = mgGetFloat("move", 0)
	speed = mgGetFloat("speed", 1)
	offset = mgGetFloat("offset", math.random() * 2 * math.pi)
	x = 0
	if mgGetBool("raycast", false) then
		local hit, wall = mgRaycast(0, 0, 0, -side * 12, 0, 0, 128)
		x = hit and wall + side * 0.12 or 0
	end
	local half = spacing() * (beams - 1) / 2 + 0.16

	-- The back holds; the lens before it is what must be hit.
	mgMaterial("steel")
	mgStatic(2)
	mgColor(0.25, 0.27, 0.31)
	back = mgCreateBody(x, place(), 0)
	mgCreateBox(back, 0.05, half + 0.05, 0.13, -side * 0.06, 0, 0)
	for i = 1, beams do
		mgCreateBox(back, 0.03, 0.035, 0.16, side * 0.02, height(i), 0)
	end
	mgMaterial("glass")
	mgStatic(2)
	mgForceLimit(mgGetFloat("strength", 0.1))
	mgColor(mgGetColor("color", 1.0, 0.35, 0.3))
	lens = mgCreateBody(x, place(), 0)
	mgCreateBox(lens, 0.05, half, 0.09, side * 0.11, 0, 0)
	burst = mgCreateSound("laser/discharge")
end

function spacing()
	return 0.36
end

function height(i)
	return (i - (beams + 1) / 2) * spacing()
end

function place()
	return move * math.sin(mgObstacleTime() * speed + offset)
end

function tick()
	local y = place()
	if move ~= 0 then
		mgMove(back, x, y, 0)
		mgMove(lens, x, y, 0)
	end
	if mgBodyIsBroken(lens) then
		if not mgIsCleared() then
			mgPlaySound(burst)
			mgClear()
		end
		return
	end
	for i = 1, beams do
		mgLaser(x + side * 0.18, y + height(i), 0, side, 0, 0)
	end
end
