-- Prepended to every room script. confSegment and nextSegment are built in; these are small helpers around them.

-- Places segments one after another until the room is `length` long, then the last one; returns where it ends.
function fillRoom(length, last, lastLength)
	local at = 0
	while at < length - lastLength do
		at = at + mgSegment(nextSegment(), -at)
	end
	return at + mgSegment(last, -at)
end
