/** The server in real browsers, and with real peers. */
@NullMarked
package org.starl.serve;

import org.jspecify.annotations.NullMarked;
