-- A glass pane on four ropes from the ceiling.
-- width, height, thickness: of the pane; strength: force limit; perpendicular: turned edge-on.

function rope(x, y, z, dz)
	local hit, rx, ry, rz = mgRaycast(x, y + 0.05, z, x, y + 12, z, 128)
	if not hit then
		ry = y + 6
	end
	mgCreateRope(pane, 0, x, y, z, x, ry, z + dz, -0.01)
end

function init()
	local w = mgGetFloat("width", 2) / 2
	local h = mgGetFloat("height", 2) / 2
	local t = mgGetFloat("thickness", 0.04) / 2

	mgMaterial("glass")
	mgForceLimit(mgGetFloat("strength", 0.1))
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	pane = mgCreateBody(0, 0, 0)
	if mgGetBool("perpendicular", false) then
		mgCreateBox(pane, t, h, w)
		rope(0, h, w * 0.85, 0.3)
		rope(0, h, w * 0.85, -0.3)
		rope(0, h, -w * 0.85, 0.3)
		rope(0, h, -w * 0.85, -0.3)
	else
		mgCreateBox(pane, w, h, t)
		rope(w * 0.85, h, 0, 0.6)
		rope(w * 0.85, h, 0, -0.6)
		rope(-w * 0.85, h, 0, 0.6)
		rope(-w * 0.85, h, 0, -0.6)
	end
end

function tick()
	if not mgIsCleared() and mgBodyIsBroken(pane) and mgCanPass() then
		mgClear()
	end
end
