-- A beam of glass from wall to wall.
-- thickness, height: of its section; maxwidth: the farthest it reaches to each side; strength: force limit.

function reach(direction, most)
	local hit, x, y, z = mgRaycast(0, 0, 0, direction * most, 0, 0, 128)
	if hit then
		return x
	end
	return direction * most
end

function init()
	local t = mgGetFloat("thickness", 0.12) / 2
	local h = mgGetFloat("height", 0.12) / 2
	local most = mgGetFloat("maxwidth", 10)
	local left = reach(-1, most)
	local right = reach(1, most)

	mgMaterial("glass")
	mgStatic(1)
	mgForceLimit(mgGetFloat("strength", 0.1))
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	bar = mgCreateBody((left + right) / 2, 0, 0)
	mgCreateBox(bar, (right - left) / 2, h, t)
end

function tick()
	if not mgIsCleared() and mgBodyIsBroken(bar) and mgCanPass() then
		mgClear()
	end
end
