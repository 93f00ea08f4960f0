-- A beam of glass from wall to wall.
-- thickness, height: of its section; blocker: a pane hangs from it down to what is below; maxwidth: the farthest it reaches to each side;
-- move: how far it goes up and down as the camera comes nearer, with offset and speed; strength: force limit.

function reach(dx, dy, most)
	local hit, x, y, z = mgRaycast(0, 0, 0, dx * most, dy * most, 0, 128)
	if hit then
		return x + y
	end
	return (dx + dy) * most
end

function init()
	local t = mgGetFloat("thickness", 0.12) / 2
	local h = mgGetFloat("height", 0.12) / 2
	local most = mgGetFloat("maxwidth", 10)
	move = mgGetFloat("move", 0)
	offset = mgGetFloat("offset", 0)
	speed = mgGetFloat("speed", 1)
	local left = reach(-1, 0, most)
	local right = reach(1, 0, most)
	local half = (right - left) / 2 - (move == 0 and 0 or 0.02)

	mgMaterial("glass")
	mgStatic(move == 0 and 1 or 2)
	mgForceLimit(mgGetFloat("strength", 0.1))
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	middle = (left + right) / 2
	bar = mgCreateBody(middle, 0, 0)
	mgCreateBox(bar, half, h, t)
	if mgGetBool("blocker", false) then
		local drop = -reach(0, -1, 10) / 2 - math.abs(move) / 2
		if drop > 2 * h then
			mgCreateBox(bar, half, drop - h / 2, 0.02, 0, -h - (drop - h / 2), 0)
		end
	end
end

function tick()
	if move ~= 0 then
		mgMove(bar, middle, move * math.sin(mgCameraDistance() * speed + offset), 0)
	end
	if not mgIsCleared() and mgBodyIsBroken(bar) and mgCanPass() then
		mgClear()
	end
end
