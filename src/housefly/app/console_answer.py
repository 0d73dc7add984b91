"""Whether the console answers: its port is open long before."""

from __future__ import annotations

import http.client
import ssl

from housefly.config.site import Site

_PATIENCE = 0.5
"""How long it may take to answer [s]."""
_WILDCARDS = {"0.0.0.0": "127.0.0.1", "::": "::1"}


def console_answers(site: Site) -> bool:
    """Return whether a browser of this machine would get a page from the console now."""
    host = _WILDCARDS.get(site.web.host, site.web.host)
    try:
        line = _line(host, site)
        try:
            line.request("HEAD", "/")
            return line.getresponse().status < 500
        finally:
            line.close()
    except (OSError, http.client.HTTPException):
        return False


def _line(host: str, site: Site) -> http.client.HTTPConnection:
    if not site.web.tls_certificate:
        return http.client.HTTPConnection(host, site.web.port, timeout=_PATIENCE)
    # Nothing is believed of what it says, and nothing is told to it.
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    return http.client.HTTPSConnection(host, site.web.port, timeout=_PATIENCE, context=context)
