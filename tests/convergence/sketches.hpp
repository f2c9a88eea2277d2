#pragma once

void sketches();
