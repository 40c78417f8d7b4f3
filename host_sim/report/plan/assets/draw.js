'use strict';

drawPage({});
