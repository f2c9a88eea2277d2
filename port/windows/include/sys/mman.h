// Nothing: memory has no pages here that one could advise about.
#pragma once
