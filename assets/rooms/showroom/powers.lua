-- Every power-up, and glass to try them on; a second one of each floats further on, put there by the script.

function init()
	mgMusic("hall")
	mgFogColor(0.20, 0.24, 0.30, 0.80, 0.84, 0.90)
	local z = 0
	for i = 1, 3 do
		z = z + mgSegment("showroom/powers", -z)
	end
	mgPowerUp("nitroballs", 0, 2.4, -30)
	mgPowerUp("slowmotion", 0, 2.4, -62)
	mgLength(z)
end
