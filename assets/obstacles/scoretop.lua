-- A crystal worth three balls: a pyramid that stands where it is put.
-- static: false lets it be pushed over; raycast: drop it onto what is below.

function init()
	local at = 0
	if mgGetBool("raycast", false) then
		local hit, x, y, z = mgRaycast(0, 0, 0, 0, -12, 0, 128)
		if hit then
			at = y
		end
	end

	mgMaterial("glass")
	if mgGetBool("static", true) then
		mgStatic(1)
	end
	mgCategory(4)
	mgForceLimit(0.02)
	mgColor(mgGetColor("color", 0.35, 0.75, 1.0))
	mgScore(3, 0, at + 0.6, 0)
	crystal = mgCreateBody(0, at, 0)
	mgShapeScale(0.4, 0.55, 0.4)
	mgCreateMesh(crystal, "pyramid", 0, 0.28, 0)
end

function tick()
	if not mgIsCleared() and mgBodyIsBroken(crystal) then
		mgClear()
	end
end
