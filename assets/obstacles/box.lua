-- A block of glass that stands where it is put.
-- sizeX, sizeY, sizeZ: half extents; strength: force limit; raycast: drop it onto what is below.

function init()
	local x = mgGetFloat("sizeX", 0.5)
	local y = mgGetFloat("sizeY", 0.5)
	local z = mgGetFloat("sizeZ", 0.5)
	local at = 0
	if mgGetBool("raycast", false) then
		local hit, rx, ry, rz = mgRaycast(0, 0, 0, 0, -12, 0, 128)
		if hit then
			at = ry + y + 0.002
		end
	end

	mgMaterial("glass")
	mgForceLimit(mgGetFloat("strength", 0.1))
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	block = mgCreateBody(0, at, 0)
	mgCreateBox(block, x, y, z)
end

function tick()
	if not mgIsCleared() and mgBodyIsBroken(block) then
		mgClear()
	end
end
