"""Make the small test images of the feature scenes: python scenes/features/images/make_images.py.

PNG files are written by hand, because palette images with a transparency chunk are what the scenes test and few
libraries write them; GIF files go through Pillow, the other formats through OpenImageIO.
"""

import struct
import zlib
from pathlib import Path

import numpy as np
import OpenImageIO as oiio
from PIL import Image as Pillow

HERE = Path(__file__).parent
Bytes = np.ndarray[tuple[int, ...], np.dtype[np.uint8]]


def chunk(kind: bytes, data: bytes) -> bytes:
    """One PNG chunk with its length and checksum."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_png(name: str, rows: np.ndarray, colour_type: int, extra: bytes = b"") -> None:
    """Write `rows` (height, width[, channels]; uint8 or uint16) as a PNG; `extra` holds ready chunks."""
    depth = rows.dtype.itemsize * 8
    flat = rows.astype(rows.dtype.newbyteorder(">")).reshape(rows.shape[0], -1)
    body = b"".join(b"\0" + row.tobytes() for row in flat)
    header = struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], depth, colour_type, 0, 0, 0)
    data = chunk(b"IHDR", header) + extra + chunk(b"IDAT", zlib.compress(body, 9)) + chunk(b"IEND", b"")
    (HERE / name).write_bytes(b"\x89PNG\r\n\x1a\n" + data)


def flag() -> Bytes:
    """A 24 by 16 picture without symmetry: gradients, a bar, a diagonal and a dark corner."""
    y, x = np.mgrid[0:16, 0:24]
    rgb = np.stack([40 + 9 * x, 230 - 12 * y, 60 + 5 * (x + y)], axis=-1)
    rgb[3:6, 4:20] = (240, 220, 60)
    rgb[6:14, 4:7] = (200, 30, 40)
    rgb[abs(x - y - 6) < 1] = (20, 40, 160)
    rgb[12:, 20:] = (15, 10, 30)
    return np.clip(rgb, 0, 255).astype(np.uint8)


def main() -> None:
    rgb = flag()
    y, x = np.mgrid[0:16, 0:24]
    write_png("flag.png", rgb, 2)
    alpha = np.clip(255 - 14 * np.hypot(x - 12, 1.5 * (y - 8)), 0, 255).astype(np.uint8)
    write_png("badge.png", np.dstack([rgb, alpha]), 6)
    index = ((x // 4 + y // 4) % 4).astype(np.uint8)
    index[5:9, 10:20] = 4
    palette = bytes([230, 220, 190, 200, 60, 40, 40, 120, 190, 60, 150, 70, 30, 20, 60])
    write_png("tiles.png", index, 3, chunk(b"PLTE", palette))
    tiles = Pillow.fromarray(index, "P")
    tiles.putpalette(palette)
    tiles.save(HERE / "tiles.gif", interlace=0)
    tiles.save(HERE / "tiles_interlaced.gif", interlace=1)
    hills = 0.5 + 0.25 * np.sin(x / 3.0) * np.cos(y / 2.5) + 0.25 * np.sin((x + 2 * y) / 5.0)
    write_png("hills.png", (hills * 255).astype(np.uint8), 0)
    write_png("hills16.png", (hills * 65535).astype(np.uint16), 0)
    write_png("flag_gamma.png", rgb, 2, chunk(b"gAMA", struct.pack(">I", 100000)))
    for name in ("flag.tga", "flag.ppm", "flag.tif", "flag.jpg", "flag.bmp"):
        image = oiio.ImageBuf(rgb)
        image.write(str(HERE / name))
    k, j, i = np.mgrid[0:6, 0:8, 0:10]
    voxels = np.clip(255 * (1 - np.sqrt((i - 4.0) ** 2 + (j - 4.5) ** 2 + (2 * k - 4.0) ** 2) / 6), 0, 255)
    (HERE / "cloud.df3").write_bytes(struct.pack(">HHH", 10, 8, 6) + voxels.astype(np.uint8).tobytes())
    light = (rgb / 255.0) ** 2.2 * 2.0
    for name in ("flag.hdr", "flag.exr"):
        oiio.ImageBuf(light.astype(np.float32)).write(str(HERE / name))


if __name__ == "__main__":
    main()
