-- A crystal worth five balls: a diamond that hovers and turns.
-- raycast: hover over what is below.

function init()
	local at = 0
	if mgGetBool("raycast", false) then
		local hit, x, y, z = mgRaycast(0, 0, 0, 0, -12, 0, 128)
		if hit then
			at = y
		end
	end
	height = at + 0.65

	mgMaterial("glass")
	mgCategory(4)
	mgForceLimit(0.02)
	mgColor(mgGetColor("color", 1.0, 0.75, 0.25))
	mgScore(5, 0, height + 0.5, 0)
	crystal = mgCreateBody(0, height, 0)
	mgShapeScale(0.44, 0.74, 0.44)
	mgCreateMesh(crystal, "diamond")
	mgMove(crystal, 0, height, 0, 3, 2)
end

function tick()
	if mgIsCleared() then
		return
	end
	if mgBodyIsBroken(crystal) then
		mgReleaseMotion(crystal)
		mgClear()
		return
	end
	mgRotate(crystal, 0, mgObstacleTime() * 1.4, 0, 3, 10)
end
