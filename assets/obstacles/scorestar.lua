-- A crystal worth ten balls: a star of three crossed spikes that tumbles as it hovers.
-- raycast: hover over what is below.

function init()
	local at = 0
	if mgGetBool("raycast", false) then
		local hit, x, y, z = mgRaycast(0, 0, 0, 0, -12, 0, 128)
		if hit then
			at = y
		end
	end
	height = at + 0.7

	mgMaterial("glass")
	mgCategory(4)
	mgForceLimit(0.02)
	mgColor(mgGetColor("color", 0.95, 0.4, 0.55))
	mgScore(10, 0, height + 0.5, 0)
	crystal = mgCreateBody(0, height, 0)
	mgShapeScale(0.86, 0.26, 0.26)
	mgCreateMesh(crystal, "diamond")
	mgShapeScale(0.26, 0.86, 0.26)
	mgCreateMesh(crystal, "diamond")
	mgShapeScale(0.26, 0.26, 0.86)
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
	local t = mgObstacleTime()
	mgRotate(crystal, t * 0.9, t * 1.3, 0, 3, 10)
end
