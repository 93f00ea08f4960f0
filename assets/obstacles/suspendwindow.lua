-- A glass pane on four ropes from the ceiling.
-- width, height, thickness: of the pane; strength: force limit; plate: a steel strip along its top carries it; perpendicular: turned
-- edge-on.

function rope(x, y, z, dz)
	local hit, rx, ry, rz = mgRaycast(x, y + 0.05, z, x, y + 12, z, 128)
	if not hit then
		ry = y + 6
	end
	mgCreateRope(carrier, 0, x, y, z, x, ry, z + dz, -0.01)
end

function init()
	local w = mgGetFloat("width", 2) / 2
	local h = mgGetFloat("height", 2) / 2
	local t = mgGetFloat("thickness", 0.02) / 2
	local strength = mgGetFloat("strength", 0.1)
	local isEdgeOn = mgGetBool("perpendicular", false)
	local x = isEdgeOn and t or w
	local z = isEdgeOn and w or t

	mgMaterial("glass")
	mgForceLimit(strength)
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	pane = mgCreateBody(0, 0, 0)
	mgCreateBox(pane, x, h, z)
	carrier = pane
	local top = h
	if mgGetBool("plate", false) then
		mgMaterial("steel")
		mgColor(0.35, 0.4, 0.45)
		carrier = mgCreateBody(0, h + 0.03, 0)
		mgCreateBox(carrier, x + 0.01, 0.03, z + 0.01)
		mgCreateBallJoint(carrier, pane, 0.7 * x, h, 0.7 * z)
		mgCreateBallJoint(carrier, pane, -0.7 * x, h, -0.7 * z)
		top = h + 0.06
	end
	if isEdgeOn then
		rope(0, top, w * 0.85, 0.3)
		rope(0, top, w * 0.85, -0.3)
		rope(0, top, -w * 0.85, 0.3)
		rope(0, top, -w * 0.85, -0.3)
	else
		rope(w * 0.85, top, 0, 0.6)
		rope(w * 0.85, top, 0, -0.6)
		rope(-w * 0.85, top, 0, 0.6)
		rope(-w * 0.85, top, 0, -0.6)
	end
end

function tick()
	if not mgIsCleared() and mgBodyIsBroken(pane) and mgCanPass() then
		mgClear()
	end
end
