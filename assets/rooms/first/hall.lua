-- The first room: a long hall. What a throw does is shown first with one window in the way, then panes on ropes, bars and blocks.

function init()
	mgMusic("hall")
	mgFogColor(0.30, 0.52, 0.64, 0.88, 0.96, 0.92)
	mgReverb(0.35, 0.7, 0.3)
	mgParticles("fallinglite")

	local l = 0
	l = l + mgSegment("first/hall/start", -l)
	l = l + mgSegment("first/hall/window", -l)
	l = l + mgSegment("first/hall/crystals", -l)
	l = l + mgSegment("first/hall/hanging", -l)
	l = l + mgSegment("first/hall/bars", -l)
	l = l + mgSegment("first/hall/blocks", -l)
	l = l + mgSegment("first/hall/windows", -l)
	l = l + mgSegment("first/hall/columns", -l)
	l = l + mgSegment("first/hall/curtain", -l)
	l = l + mgSegment("first/hall/stacks", -l)
	l = l + mgSegment("first/hall/door", -l)
	mgLength(l)
end
