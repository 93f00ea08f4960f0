-- A glass pane that slides from side to side on a rail.
-- width: how far its travel reaches altogether; height, panewidth, thickness: of the pane; speed: radians of its swing a second; beat: it
-- goes over with every second beat instead; offset: where it starts (default: anywhere); blocker: fixed panes stand where it does not go;
-- strength: force limit.

function init()
	width = mgGetFloat("width", 2)
	local h = mgGetFloat("height", 2) / 2
	local p = mgGetFloat("panewidth", 0.4) / 2
	local t = mgGetFloat("thickness", 0.02) / 2
	local strength = mgGetFloat("strength", 0.2)
	speed = mgGetFloat("speed", 1)
	beat = mgGetBool("beat", false)
	offset = mgGetFloat("offset", math.random() * 2 * math.pi)
	swing = math.max(0, width / 2 - p)

	mgMaterial("steel")
	mgStatic(1)
	mgColor(0.35, 0.4, 0.45)
	local rail = mgCreateBody(0, h + 0.06, 0)
	mgCreateBox(rail, width / 2 + 0.05, 0.04, 0.05)

	mgMaterial("glass")
	mgForceLimit(strength)
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	if mgGetBool("blocker", false) then
		mgStatic(1)
		for side = -1, 1, 2 do
			local post = mgCreateBody(side * (width / 2 + p + 0.02), 0, 0)
			mgCreateBox(post, p, h, t)
		end
	end
	mgStatic(2)
	pane = mgCreateBody(place(), 0, 0)
	mgCreateBox(pane, p, h, t)
end

function place()
	if beat then
		return swing * math.cos(mgGetBeat(0.4) * math.pi / 2 + offset)
	end
	return swing * math.sin(mgObstacleTime() * speed + offset)
end

function tick()
	mgMove(pane, place(), 0, 0)
	if not mgIsCleared() and mgBodyIsBroken(pane) and mgCanPass() then
		mgClear()
	end
end
