-- The third room, which ends at the checkpoint: dusk, brass, and glass that moves. A clear stretch with crystals comes before each hard one.

function init()
	mgMusic("vault")
	mgFogColor(0.05, 0.10, 0.16, 0.20, 0.50, 0.48)
	mgReverb(0.6, 1.1, 0.25)
	mgEcho(0.15, 0.3, 0.3, 0.5)
	mgParticles("lowrising")

	local l = 0
	l = l + mgSegment("first/vault/start", -l)
	l = l + mgSegment("first/vault/ladder", -l)
	l = l + mgSegment("first/vault/gate", -l)
	l = l + mgSegment("first/vault/nave", -l)
	l = l + mgSegment("first/vault/press", -l)
	l = l + mgSegment("first/vault/veil", -l)
	l = l + mgSegment("first/vault/lattice", -l)
	l = l + mgSegment("first/vault/fans", -l)
	l = l + mgSegment("first/vault/nave", -l)
	l = l + mgSegment("first/vault/swing", -l)
	l = l + mgSegment("first/vault/gate", -l)
	l = l + mgSegment("first/vault/mill", -l)
	l = l + mgSegment("first/vault/door", -l)
	mgLength(l)
end
