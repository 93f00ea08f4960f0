-- A glass pane held all around by a steel frame.
-- width, height: of the pane; thickness: of the glass; strength: force limit; frame: thickness of the frame (0: the walls hold the pane).

function init()
	local w = mgGetFloat("width", 4) / 2
	local h = mgGetFloat("height", 2) / 2
	local t = mgGetFloat("thickness", 0.04) / 2
	local f = mgGetFloat("frame", 0.06) / 2

	if f > 0 then
		mgMaterial("steel")
		mgStatic(1)
		mgColor(0.35, 0.4, 0.45)
		local frame = mgCreateBody(0, 0, 0)
		mgCreateBox(frame, w, f, 0.05, 0, h - f, 0)
		mgCreateBox(frame, w, f, 0.05, 0, f - h, 0)
		mgCreateBox(frame, f, h - 2 * f, 0.05, f - w, 0, 0)
		mgCreateBox(frame, f, h - 2 * f, 0.05, w - f, 0, 0)
	end

	mgMaterial("glass")
	mgStatic(1)
	mgForceLimit(mgGetFloat("strength", 0.1))
	mgColor(mgGetColor("color", 0.7, 0.9, 0.95))
	pane = mgCreateBody(0, 0, 0)
	mgCreateBox(pane, w - 2 * f, h - 2 * f, t)
end

function tick()
	if not mgIsCleared() and mgBodyIsBroken(pane) and mgCanPass() then
		mgClear()
	end
end
