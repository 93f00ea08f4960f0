-- A player of the first level who aims by what is in sight: careless, average or good.
--   brittle smoke assets/player.lua --set skill=average --seeds 20
--   brittle smoke assets/player.lua --record assets/replays/first-rooms.brt

local skills = {
	-- every: ticks between two looks; error: of the aim [at 1 m]; threats, crystals: how far off they are thrown at [m];
	-- care: part of the crystals that are seen; waste: part of the looks that end in a throw at nothing; again: ticks until a second try
	careless = { every = 20, error = 0.056, threats = 10, crystals = 14, care = 0.7, waste = 0.04, again = 20 },
	average = { every = 15, error = 0.030, threats = 11, crystals = 16, care = 0.8, waste = 0.04, again = 25 },
	good = { every = 6, error = 0.008, threats = 14, crystals = 19, care = 1, waste = 0, again = 12 },
	-- throws nothing at all
	idle = { every = 60, error = 0, threats = 0, crystals = 0, care = 0, waste = 0, again = 0 },
}

local name = setting("skill", "good")
local skill = skills[name] or error("skill=" .. name .. ": expected careless, average, good or idle", 0)
local thrown = {} -- by thing: the tick from which another throw at it makes sense
local skipped = {} -- crystals that are left alone

-- Where to aim so that a ball meets what is at (x, y, ahead) now and moves with (vx, vy, va). A ball goes 20 m/s faster than the camera
-- and is lobbed: it is back on the aimed line after 10 m.
local function aim(x, y, ahead, vx, vy, va)
	local v = 20 + speed()
	local t = 0
	for _ = 1, 3 do
		local tx, ty, ta = x + vx * t, y + vy * t, ahead + va * t
		t = math.max(0, math.sqrt(tx * tx + ty * ty + ta * ta) - 0.5) / v
	end
	x, y, ahead = x + vx * t, y + vy * t, ahead + va * t
	y = y - gravity() / 2 * t * (10 / v - t)
	return x / ahead, y / ahead, t
end

local function spread()
	return (math.random() + math.random() - 1) * skill.error
end

-- How urgent: the smaller, the sooner; nil if it is nothing to throw at.
local function urgency(kind, ahead, id, clear, aside, breaks, vx, vy)
	if (thrown[id] or 0) > tick() then
		return nil
	end
	if kind == "crystal" then
		if skipped[id] == nil then
			skipped[id] = math.random() >= skill.care
		end
		if not clear or skipped[id] or ahead > skill.crystals or ahead < 1.5 then
			return nil
		end
		return ahead + 3
	elseif kind == "power-up" then
		return clear and ahead < skill.crystals and ahead > 1.5 and ahead + 3 or nil
	elseif kind == "button" then
		return clear and ahead < skill.threats and ahead or nil
	end
	local reach = math.abs(vx) + math.abs(vy) > 0.2 and 1.2 or 0.32
	if not breaks or aside > reach or ahead > skill.threats or ahead < 0.8 then
		return nil
	end
	return ahead
end

local function choose()
	local best, target
	for i = 1, look() do
		local kind, x, y, ahead, vx, vy, va, id, clear, aside, breaks = seen(i)
		local now = urgency(kind, ahead, id, clear, aside, breaks, vx, vy)
		if now and (not best or now < best) then
			best = now
			target = { x, y, ahead, vx, vy, va, id }
		end
	end
	return target
end

local function act()
	if math.random() < skill.waste then
		throw { x = (math.random() - 0.5) * 0.8, y = (math.random() - 0.5) * 0.4 }
		return
	end
	local target = choose()
	if target then
		for _, kind in ipairs({ "nitroballs", "ballfrenzy", "slowmotion", "barrel" }) do
			local count, left = power_ups(kind)
			if count > 0 and left == 0 then
				use(kind)
			end
		end
		local x, y, t = aim(target[1], target[2], target[3], target[4], target[5], target[6])
		thrown[target[7]] = tick() + math.floor(t * 60) + skill.again
		throw { x = x + spread(), y = y + spread() }
	end
end

level("first")
seed(1)
while phase() == "playing" do
	if skill.threats > 0 then
		act()
	end
	run(tick() + skill.every)
end
expect_finite()
expect_problems(0)
if name == "good" then
	expect_phase("checkpoint")
end
if name == "idle" then
	expect_phase("game over")
	expect_room(0)
end
