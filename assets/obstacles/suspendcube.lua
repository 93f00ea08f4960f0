-- A block of glass on four ropes from the ceiling.
-- width, height, depth: of the block; vx, vz: the push it starts with; rot: how far it is turned about the upright axis; strength: force limit.

function rope(x, y, z, away)
	local hit, rx, ry, rz = mgRaycast(x, y + 0.05, z, x, y + 12, z, 128)
	if not hit then
		ry = y + 6
	end
	mgCreateRope(block, 0, x, y, z, x * away, ry, z * away, -0.01)
end

function init()
	local w = mgGetFloat("width", 2) / 2
	local h = mgGetFloat("height", 1) / 2
	local d = mgGetFloat("depth", 0.3) / 2
	local rot = mgGetFloat("rot", 0)
	local vx = mgGetFloat("vx", 0)
	local vz = mgGetFloat("vz", 0)

	mgMaterial("glass")
	mgForceLimit(mgGetFloat("strength", 0.2))
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	block = mgCreateBody(0, 0, 0, 0, rot, 0)
	mgCreateBox(block, w, h, d)
	local c = math.cos(rot)
	local s = math.sin(rot)
	for _, side in ipairs({ -0.9, 0.9 }) do
		for _, front in ipairs({ -0.8, 0.8 }) do
			local x = side * w
			local z = front * d
			rope(x * c + z * s, h, z * c - x * s, 1.15)
		end
	end
	if vx ~= 0 or vz ~= 0 then
		mgSetVel(block, vx, 0, vz)
	end
end

function tick()
	if not mgIsCleared() and mgBodyIsBroken(block) and mgCanPass() then
		mgClear()
	end
end
