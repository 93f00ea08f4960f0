-- A fan of glass arms that turns about the camera's way.
-- length, width, thickness: of an arm; arms: how many; radius: of the hub; endplate: a plate across the end of each arm; speed: radians a
-- second; drive: false lets it hang and swing; beat: it turns by one arm every so many beats instead; offset: where it starts (default:
-- anywhere); strength: force limit; axlecolor: of the ends of its axle.

-- From the hub up to the ceiling: what the fan seems to hang on.
function rope(side)
	local hit, x, y, z = mgRaycast(side * 0.8, 0.5, 0, side * 0.8, 12, 0, 128)
	if hit then
		mgCreateRope(fan, 0, 0, 0, 0, x, y, 0, 0.001)
	end
end

function init()
	local l = mgGetFloat("length", 1)
	local w = mgGetFloat("width", 0.1) / 2
	local t = mgGetFloat("thickness", 0.1) / 2
	local r = mgGetFloat("radius", 0.2)
	arms = math.max(1, math.min(6, mgGetInt("arms", 2)))
	speed = mgGetFloat("speed", 2)
	drive = mgGetBool("drive", true)
	beat = mgGetFloat("beat", 0)
	local offset = mgGetFloat("offset", math.random() * 2 * math.pi)
	local isPlated = mgGetBool("endplate", false)

	mgMaterial("glass")
	mgForceLimit(mgGetFloat("strength", 0.15))
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	fan = mgCreateBody(0, 0, 0, 0, 0, offset)
	hub = mgCreateCylinder(fan, r, t, 0, 0, 0, math.pi / 2, 0, 0)
	-- The axle, seen before and behind the hub; its ends are glass too, so that they break with it.
	local red, green, blue = mgGetColor("axlecolor", 0.9, 0.5, 0.16)
	mgColor(red, green, blue)
	for side = -1, 1, 2 do
		mgCreateCylinder(fan, r * 0.5, 0.1, 0, 0, side * (t + 0.1), math.pi / 2, 0, 0)
	end
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	for i = 0, arms - 1 do
		-- An arm grows from a side of the hub, which has twelve: what shares no face would not hold together.
		local a = (math.floor(i * 12 / arms) + 0.5) * math.pi / 6
		local c = math.cos(a)
		local s = math.sin(a)
		local out = r * math.cos(math.pi / 12) + l / 2
		mgCreateBox(fan, l / 2, w, t, out * c, out * s, 0, 0, 0, a)
		if isPlated then
			out = out + l / 2 + 0.03
			mgCreateBox(fan, 0.03, w * 3, t, out * c, out * s, 0, 0, 0, a)
		end
	end
	mgCreateHingeJoint(fan, 0, 0, 0, 0, 0, 0, 1)
	rope(-1)
	rope(1)
	angle = turned()
end

function turned()
	if beat > 0 then
		return mgGetBeat(0.4) / beat * 2 * math.pi / arms
	end
	return mgObstacleTime() * speed
end

function tick()
	local now = turned()
	local body = mgGetShapeBody(hub)
	if drive and body ~= 0 and not mgShapeIsBroken(hub) then
		mgSetAngVel(body, 0, 0, (now - angle) * 60)
	end
	angle = now
	if not mgIsCleared() and mgBodyIsBroken(fan) and mgCanPass() then
		mgClear()
	end
end
