function init()
	mgLength(160
end
