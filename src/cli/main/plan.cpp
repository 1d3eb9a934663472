#include <iostream>

#include "../plan_command.h"

int main(int argc, char** argv)
{
  return fourwis::plan_command(argc, argv, std::cout, std::cerr);
}
