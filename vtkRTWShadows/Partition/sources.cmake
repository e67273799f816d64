list(APPEND rtw_classes
  Partition/vtkDepthSplitShadowMapPartition
  Partition/vtkShadowMapPartition)
set(rtw_room_Partition
  Partition/rtwDepthBins.glsl
  Partition/rtwDepthSplits.h
  Partition/rtwDepthSplitStage.cxx
  Partition/rtwDepthSplitStage.h
  Partition/rtwPartitionStage.h
  Partition/rtwSeenRange.glsl
  Partition/rtwSplitByBins.glsl
  Partition/rtwStorageFactor.h
  Partition/rtwWriteIntervals.glsl)
list(APPEND rtw_pure
  Partition/rtwDepthSplits.cxx
  Partition/rtwStorageFactor.cxx)
