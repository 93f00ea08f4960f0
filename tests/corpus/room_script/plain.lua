function init()
  mgFogColor(0.1, 0.2, 0.3, 0.4, 0.5, 0.6)
  mgReverb(0.4, 0.6, 0.2) mgEcho(0.1, 0.2, 0.3, 0.4) mgLowPass(0.1) mgGravity(0.5) mgSetRotation(1, 0.2) mgParticles("bubbles")
  local l = 0
  for i = 1, 3 do l = l + mgSegment("test/hall", -l) end
  mgObstacle("glass", 0, 1, -8, "color=1 0 0") mgBox(1, 1, 1, 0, 0, -4) mgColor(1, 0, 0) mgPowerUp("nitroballs", 0, 1, -3)
  mgSet("level.egg", "1") mgLength(l + mgRndInt(1, 5)) mgMusic("1") mgSetDifficulty(0.5)
end
function tick() end
