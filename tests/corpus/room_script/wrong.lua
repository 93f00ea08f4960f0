function init()
  mgObstace("x") mgSegment(nil, {}) mgLength("a") mgLength(0/0) mgBox(1e30, -1, 0/0, math.huge, 0, 0)
  error({}) string.rep("x", 1e9) setmetatable({}, {__index = function(t, k) return t[k] end}).a()
end
