void main()
{
  rtwWrite(rtwCentreOfTexel());
}
