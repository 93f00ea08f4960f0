function init() while true do t = {t} end end
