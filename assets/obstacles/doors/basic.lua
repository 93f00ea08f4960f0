-- Two leaves that slide apart when the camera comes near; with buttons they wait until every button has been hit.
-- width, height: of the opening; distance: at which it opens by itself; buttons: 0, 1 or 2; emblem: 1 to 4, painted on each leaf
-- (default: none).

function init()
	w = mgGetFloat("width", 2) / 2
	h = mgGetFloat("height", 2) / 2
	distance = mgGetFloat("distance", 5)
	count = mgGetInt("buttons", 0)
	emblem = mgGetInt("emblem", 0)
	open = false

	mgMaterial("door")
	mgColor(mgGetColor("color", 0.5, 0.55, 0.6))
	left = mgCreateBody(-w / 2, 0, 0)
	mgCreateBox(left, w / 2, h, 0.06)
	right = mgCreateBody(w / 2, 0, 0)
	mgCreateBox(right, w / 2, h, 0.06)

	-- In front of the wall that the door stands in, up to 0.6 thick.
	if count == 1 then
		first = mgCreateButton(0, h + 0.35, 0.36)
	elseif count >= 2 then
		first = mgCreateButton(-w - 0.4, 0, 0.36)
		second = mgCreateButton(w + 0.4, 0, 0.36)
	end
end

function isDue()
	if count == 0 then
		return mgCameraDistance() < distance
	elseif count == 1 then
		return mgIsButtonDown(first)
	end
	return mgIsButtonDown(first) and mgIsButtonDown(second)
end

function tick()
	if not open and isDue() then
		open = true
		mgClear()
	end
	if open then
		mgMove(left, -w * 1.48, 0, 0, 10, 3)
		mgMove(right, w * 1.48, 0, 0, 10, 3)
	end
end

function draw()
	if emblem > 0 then
		local size = math.min(w / 2, h) * 0.55
		mgColor(0.95, 0.97, 1, 0.85)
		mgBodyDecal(left, -emblem, size, size, 0, 0, 0.06)
		mgBodyDecal(right, -emblem, size, size, 0, 0, 0.06)
	end
end
